# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause

# cmake --install: programs, configuration, units and man pages where Debian has them. `--prefix /usr` for a vehicle.
include(GNUInstallDirs)
set(units ${PROJECT_SOURCE_DIR}/systemd)

install(TARGETS hindsightd hindsight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(PROGRAMS ${PROJECT_SOURCE_DIR}/tools/spy/hindsight-spy DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_BINARY_DIR}/hindsight-spy.jar DESTINATION ${CMAKE_INSTALL_DATADIR}/java OPTIONAL)
file(GLOB configuration CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/config/*.toml ${PROJECT_SOURCE_DIR}/config/*.dbc
  ${PROJECT_SOURCE_DIR}/config/*.yaml)
install(FILES ${configuration} DESTINATION /etc/hindsight)
install(FILES ${PROJECT_SOURCE_DIR}/docs/man/hindsightd.8 DESTINATION ${CMAKE_INSTALL_MANDIR}/man8)
install(FILES ${PROJECT_SOURCE_DIR}/docs/man/hindsight.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

# systemd does not search PATH's folders for programs of another prefix: the unit names the installed one.
install(CODE "
  file(READ ${units}/hindsightd.service unit)
  string(REPLACE /usr/bin/ \${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/ unit \"\${unit}\")
  file(WRITE ${PROJECT_BINARY_DIR}/hindsightd.service \"\${unit}\")")
install(FILES ${PROJECT_BINARY_DIR}/hindsightd.service DESTINATION lib/systemd/system)
install(FILES ${units}/70-hindsight.rules DESTINATION lib/udev/rules.d)
install(FILES ${units}/80-hindsight-can0.network DESTINATION lib/systemd/network)
install(FILES ${units}/hindsight.sysusers DESTINATION lib/sysusers.d RENAME hindsight.conf)
install(FILES ${units}/hindsight.tmpfiles DESTINATION lib/tmpfiles.d RENAME hindsight.conf)
install(FILES ${units}/60-hindsight.sysctl DESTINATION lib/sysctl.d RENAME 60-hindsight.conf)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/sim_replay/courses/ DESTINATION ${CMAKE_INSTALL_DATADIR}/hindsight/courses)
